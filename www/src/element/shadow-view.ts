// The view, with the styles that it has in a shadow root.
import board from "../style/board.css?inline";
import charts from "../style/charts.css?inline";
import colours from "../style/colours.css?inline";
import compare from "../style/compare.css?inline";
import controls from "../style/controls.css?inline";
import delivery from "../style/delivery.css?inline";
import edit from "../style/edit.css?inline";
import exercise from "../style/exercise.css?inline";
import gallery from "../style/gallery.css?inline";
import goals from "../style/goals.css?inline";
import guest from "../style/guest.css?inline";
import help from "../style/help.css?inline";
import page from "../style/page.css?inline";
import play from "../style/play.css?inline";
import print from "../style/print.css?inline";
import share from "../style/share.css?inline";
import solve from "../style/solve.css?inline";
import steps from "../style/steps.css?inline";
import text from "../style/text.css?inline";
import tour from "../style/tour.css?inline";
import views from "../style/views.css?inline";

export { View } from "./view.js";

/** In the order in which they go before each other. */
export const styles: readonly (readonly [name: string, text: string])[] = [
  ["guest", guest],
  ["colours", colours],
  ["page", page],
  ["board", board],
  ["controls", controls],
  ["goals", goals],
  ["delivery", delivery],
  ["play", play],
  ["exercise", exercise],
  ["tour", tour],
  ["solve", solve],
  ["compare", compare],
  ["charts", charts],
  ["edit", edit],
  ["gallery", gallery],
  ["share", share],
  ["help", help],
  ["steps", steps],
  ["text", text],
  ["views", views],
  ["print", print],
];
