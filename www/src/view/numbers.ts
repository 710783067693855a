// Numbers as the page writes them.

const short = new Intl.NumberFormat("en", { maximumFractionDigits: 3 });
const whole = new Intl.NumberFormat("en", { maximumFractionDigits: 0 });

/** At most three decimals, with a true minus sign and no minus zero. */
export const shortNumber = (value: number): string => short.format(value + 0).replace("-", "−");

export const wholeNumber = (value: number): string => whole.format(value);
