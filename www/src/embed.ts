// What other pages of the same site load to use the element: one address that stays the same, while the files behind it
// change their names with what is in them. The styles come with them.
void import("./main.js");
