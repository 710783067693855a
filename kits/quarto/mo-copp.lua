-- The filter, for pandoc and Quarto: a division of the class mo-copp is a playground.

local here = pandoc.path.directory((debug.getinfo(1, "S").source:gsub("^@", "")))
local playground = dofile(pandoc.path.join({ here, "mo-copp-element.lua" }))

local function division(div)
  if not div.classes:includes("mo-copp") then return nil end
  return playground.blocks(function(name) return div.attributes[name] end, div.identifier, div.content)
end

return { { Meta = playground.read_script }, { Div = division } }
