-- The shortcode of Quarto: {{< mo-copp problem="head-fake" >}} is a playground.

local here = pandoc.path.directory((debug.getinfo(1, "S").source:gsub("^@", "")))
local playground = dofile(pandoc.path.join({ here, "mo-copp-element.lua" }))

local function shortcode(_, kwargs, meta)
  if meta then playground.read_script(meta) end
  local function get(name)
    local value = kwargs[name]
    return value and pandoc.utils.stringify(value) or nil
  end
  local caption = get("caption") or ""
  local inner = caption ~= "" and { pandoc.Plain({ pandoc.Str(caption) }) } or {}
  return pandoc.Blocks(playground.blocks(get, get("id"), inner))
end

return { ["mo-copp"] = shortcode }
