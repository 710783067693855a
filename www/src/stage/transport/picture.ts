// Cities, their places, and what is there: vehicles with what is in them, drivers, packages. What is there in some of
// the believed states only is dashed and says in how many.
import { html, nothing, type TemplateResult } from "lit";
import { wholeNumber } from "../../view/numbers.js";
import type { Load, Stay } from "./load.js";
import { signOfThing } from "./signs.js";
import type { Place, World } from "./world.js";

export function transportPicture(world: World, load: Load): TemplateResult {
  return html`<div class="world">
    ${world.cities.map(
      ({ name, places }) => html`<div class="city ${world.cities.length > 1 ? "framed" : ""}">
        ${name === "" ? nothing : html`<span class="city-name">${name}</span>`}
        ${places.map((place) => placeCard(world, load, place))}
      </div>`,
    )}
  </div>`;
}

function placeCard(world: World, load: Load, { name, ways }: Place): TemplateResult {
  return html`<div class="place-card" title=${ways.length === 0 ? name : `${name}: ${ways.join("; ")}`}>
    <b class="name">${name}</b>
    ${ways.length === 0 ? nothing : html`<small class="ways">${ways.join("; ")}</small>`}
    <div class="things">${(load.stays.get(name) ?? []).map((stay) => thing(world, load, stay))}</div>
  </div>`;
}

function thing(world: World, load: Load, stay: Stay): TemplateResult {
  const sign = world.signs.get(stay.name) ?? "package";
  const sure = stay.states === load.of;
  const inside = load.stays.get(stay.name) ?? [];
  return html`<span class="thing-box ${sign} ${sure ? "sure" : "perhaps"} ${stay.drives ? "drives" : ""}">
    ${signOfThing(sign)}<span class="name">${stay.name}</span>${
      sure ? nothing : html`<small class="in">${wholeNumber(stay.states)}/${wholeNumber(load.of)}</small>`
    }
    ${inside.length === 0 ? nothing : html`<span class="inside">${inside.map((each) => thing(world, load, each))}</span>`}
  </span>`;
}
