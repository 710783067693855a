-- What the filter and the shortcode make of a playground: the element, or the picture that stands for it.

local script = "mo-copp/mo-copp-playground.js"
local written = false

-- What the element's attributes may be; everything else stays out of the page.
local known = {
  "src", "problem", "plan", "step", "watch", "solver", "k", "j", "horizon", "hide", "link", "theme", "keys", "loading",
  "worker-url", "wasm-url", "seed", "student", "exercise", "name", "required", "disabled",
}

local escapes = { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" }
local function escaped(text)
  return (text:gsub('[&<>"]', escapes))
end

local function element(get, id)
  local parts = {}
  if id and id ~= "" then parts[#parts + 1] = string.format(' id="%s"', escaped(id)) end
  for _, name in ipairs(known) do
    local value = get(name)
    if value and value ~= "" then parts[#parts + 1] = string.format(' %s="%s"', name, escaped(value)) end
  end
  return "<mo-copp-playground" .. table.concat(parts) .. ">"
end

local function script_once()
  if written then return "" end
  written = true
  return string.format('<script type="module" src="%s"></script>\n', escaped(script))
end

local function image(picture, caption)
  return pandoc.Image(pandoc.utils.blocks_to_inlines(caption), picture)
end

-- On paper a caption is printed below its picture.
local function figure(picture, caption)
  if #caption == 0 or not pandoc.Figure then return { pandoc.Para({ image(picture, caption) }) } end
  return { pandoc.Figure({ pandoc.Plain({ image(picture, caption) }) }, { long = caption }) }
end

-- HTML gets the element, and in it the picture or the text that stands for it until it runs; every other format that alone.
local function blocks(get, id, inner)
  local picture = get("picture")
  if picture == "" then picture = nil end
  if FORMAT:match("html") or FORMAT:match("epub") or FORMAT == "revealjs" then
    -- No browser shows a PDF in a line of text.
    if picture and picture:lower():match("%.pdf$") then picture = nil end
    local result = pandoc.List({ pandoc.RawBlock("html", script_once() .. element(get, id)) })
    result:extend(picture and { pandoc.Plain({ image(picture, inner) }) } or inner)
    result:insert(pandoc.RawBlock("html", "</mo-copp-playground>"))
    return result
  end
  return picture and figure(picture, inner) or inner
end

local function read_script(meta)
  if meta["mo-copp-script"] then script = pandoc.utils.stringify(meta["mo-copp-script"]) end
end

return { blocks = blocks, read_script = read_script }
