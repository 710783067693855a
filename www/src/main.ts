// The playground of the stand-alone page, its styles and all that its first picture takes.
import "./style/colours.css";
import "./style/page.css";
import "./style/board.css";
import "./style/controls.css";
import "./style/goals.css";
import "./style/play.css";
import "./style/exercise.css";
import "./style/tour.css";
import "./style/solve.css";
import "./style/compare.css";
import "./style/charts.css";
import "./style/edit.css";
import "./style/gallery.css";
import "./style/share.css";
import "./style/help.css";
import "./style/steps.css";
import "./style/text.css";
import "./element/view.js";
import "./embed.js";
import { bringViewStyles } from "./stage/view-styles.js";

bringViewStyles(() => Promise.all([import("./style/delivery.css"), import("./style/views.css")]));
// The screen does not wait for what paper takes; without it the page is printed as it is.
import("./style/print.css").catch(() => undefined);
