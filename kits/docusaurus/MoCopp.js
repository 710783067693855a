// A playground in a page of Docusaurus.
import Head from "@docusaurus/Head";
import useBaseUrl from "@docusaurus/useBaseUrl";
import { createElement } from "react";

/** `children` stand for the playground until it runs. */
export default function MoCopp({ children, ...attributes }) {
  const script = useBaseUrl("/mo-copp/mo-copp-playground.js");
  return createElement(
    "div",
    null,
    createElement(Head, null, createElement("script", { type: "module", src: script })),
    createElement("mo-copp-playground", attributes, children),
  );
}
