// The element and its styles, for any page.
import "./style/colours.css";
import "./style/page.css";
import "./style/board.css";
import "./style/controls.css";
import "./style/goals.css";
import "./style/delivery.css";
import "./style/play.css";
import "./style/solve.css";
import "./style/compare.css";
import "./style/charts.css";
import "./style/edit.css";
import "./style/gallery.css";
import "./style/share.css";
import "./style/help.css";
import "./style/steps.css";
import "./style/text.css";
import { MoCoppPlayground } from "./element/mo-copp-playground.js";

customElements.define("mo-copp-playground", MoCoppPlayground);
