-- What the filter and the shortcode make of a playground: the element, or the picture that stands for it.

local script = "mo-copp/mo-copp-playground.js"
-- In a file that holds all it needs the script is in the page, and has no folder beside it.
local whole = "mo-copp/mo-copp-playground.single.js"
local written = false

-- What pandoc calls the formats that browsers open. A book is HTML too, but its readers run no scripts.
local pages = pandoc.List({
  "html", "html4", "html5", "chunkedhtml", "revealjs", "slidy", "slideous", "dzslides", "s5",
})

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

-- Once a page; chunks are pages of their own, and the same script twice is one.
local function script_once()
  if written and FORMAT ~= "chunkedhtml" then return "" end
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

-- Pages get the element, and in it the picture or the text that stands for it until it runs; every other format that alone.
local function blocks(get, id, inner)
  local picture = get("picture")
  local page = pages:includes(FORMAT)
  -- No browser shows a PDF in a line of text, and no book.
  local shows_pdf = not page and not FORMAT:match("^epub")
  if picture == "" or picture and picture:lower():match("%.pdf$") and not shows_pdf then picture = nil end
  if not page then return picture and figure(picture, inner) or inner end
  local result = pandoc.List({ pandoc.RawBlock("html", script_once() .. element(get, id)) })
  result:extend(picture and { pandoc.Plain({ image(picture, inner) }) } or inner)
  result:insert(pandoc.RawBlock("html", "</mo-copp-playground>"))
  return result
end

-- A filter is not told of pandoc's option --embed-resources; the metadata of its name is seen.
local function read_script(meta)
  local function is_on(name) return meta[name] ~= nil and pandoc.utils.stringify(meta[name]) == "true" end
  if meta["mo-copp-script"] then
    script = pandoc.utils.stringify(meta["mo-copp-script"])
  elseif is_on("embed-resources") or is_on("self-contained") then
    script = whole
  end
end

return { blocks = blocks, read_script = read_script }
