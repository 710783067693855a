-- The playground in documents of Quarto (a shortcode) and of pandoc (a division of the class mo-copp).

local script = "mo-copp/mo-copp-playground.js"
local written = false

-- What the element's attributes may be; everything else stays out of the page.
local known = {
  "src", "problem", "plan", "step", "watch", "solver", "k", "j", "horizon", "hide", "link", "theme", "keys", "loading",
  "worker-url", "wasm-url", "seed", "student", "exercise", "name",
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

-- What stands for the playground: the picture, or what stands in the division.
local function poster(picture, inner, caption, block)
  if not picture or picture == "" then return inner end
  return { block(pandoc.Image(caption, picture)) }
end

-- HTML gets the element around it; every other format that alone.
local function blocks(get, id, inner, caption)
  if FORMAT:match("html") or FORMAT:match("epub") or FORMAT == "revealjs" then
    local result = pandoc.List({ pandoc.RawBlock("html", script_once() .. element(get, id)) })
    local picture = get("picture")
    -- No browser shows a PDF in a line of text.
    if picture and picture:lower():match("%.pdf$") then picture = nil end
    result:extend(poster(picture, inner, caption, pandoc.Plain))
    result:insert(pandoc.RawBlock("html", "</mo-copp-playground>"))
    return result
  end
  return poster(get("picture"), inner, caption, pandoc.Para)
end

local function read_script(meta)
  if meta["mo-copp-script"] then script = pandoc.utils.stringify(meta["mo-copp-script"]) end
end

local function division(div)
  if not div.classes:includes("mo-copp") then return nil end
  local caption = pandoc.utils.blocks_to_inlines(div.content)
  return blocks(function(name) return div.attributes[name] end, div.identifier, div.content, caption)
end

-- Quarto calls this for {{< mo-copp … >}}.
local function shortcode(_, kwargs, meta)
  if meta then read_script(meta) end
  local function get(name)
    local value = kwargs[name]
    return value and pandoc.utils.stringify(value) or nil
  end
  local caption = get("caption") or ""
  local inner = caption ~= "" and { pandoc.Para({ pandoc.Str(caption) }) } or {}
  return pandoc.Blocks(blocks(get, get("id"), inner, { pandoc.Str(caption) }))
end

-- Quarto loads the file for the shortcode, and again for divisions; pandoc takes it as a filter.
if quarto and quarto.shortcode then
  return { ["mo-copp"] = shortcode }
end
return { { Meta = read_script }, { Div = division }, ["mo-copp"] = shortcode }
