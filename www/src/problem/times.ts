// Lists of a length. (Libraries that some pages still have put an `Array.from` of their own in the place of the browser's,
// which knows no iterators and calls no function: nothing here uses it.)

export function times<Item>(length: number, item: (index: number) => Item): Item[] {
  const made: Item[] = [];
  for (let index = 0; index + 1 <= length; index += 1) made.push(item(index));
  return made;
}
