// An SVG picture as pixels.
import { imageAddress } from "../view/image-address.js";

/** Sharp on a slide and on a screen of many pixels: the picture itself is as large as a slide is shown. */
const SCALE = 2;

/** Rejects with a sentence where the page may show no such image. */
export async function png(svg: string): Promise<Blob> {
  const image = await loaded(imageAddress(svg));
  const canvas = document.createElement("canvas");
  canvas.width = SCALE * image.naturalWidth;
  canvas.height = SCALE * image.naturalHeight;
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  const made = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/png"));
  if (made === null) throw new Error("The browser could make no PNG of it. The SVG can be saved all the same.");
  return made;
}

function loaded(address: string): Promise<HTMLImageElement> {
  return new Promise((resolve, reject) => {
    const image = new Image();
    image.onload = () => resolve(image);
    image.onerror = () =>
      reject(new Error("This page’s content policy allows no PNG (img-src data:). The SVG can be saved all the same."));
    image.src = address;
  });
}
