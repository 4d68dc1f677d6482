-- What somebody does at Neovim: each step waits until it is to be seen, and is told in a line of the file TOLD.
local told = {}

local function tell(...)
  table.insert(told, table.concat({ ... }, " "))
end

local function await(what, condition)
  if not vim.wait(60000, condition, 20) then
    error("waited in vain for " .. what)
  end
end

local function line(number, buffer)
  return vim.api.nvim_buf_get_lines(buffer or 0, number - 1, number, true)[1]
end

local function findings()
  return vim.diagnostic.get(0)
end

-- Whoever is asked takes the first offer.
vim.ui.select = function(items, options, choose)
  tell("offered:", options.format_item and options.format_item(items[1]) or tostring(items[1]))
  choose(items[1], 1)
end

local function drive()
  await("the server", function()
    local client = vim.lsp.get_active_clients()[1]
    return client ~= nil and client.initialized
  end)
  tell("opened:", vim.bo.filetype)

  vim.api.nvim_buf_set_lines(0, 10, 11, true, { "        closed {pressed == true} / {opens = true}" })
  await("a finding", function() return #findings() == 1 end)
  tell("broken:", findings()[1].code, findings()[1].message)

  vim.api.nvim_win_set_cursor(0, { 11, #line(11) - 1 })
  vim.lsp.buf.code_action()
  await("a repair", function() return #findings() == 0 end)
  tell("mended:", line(11))

  vim.api.nvim_win_set_cursor(0, { 4, 20 })
  vim.lsp.buf.rename("pushed")
  await("a new name", function() return line(4):find("pushed") end)
  local house = vim.fn.bufnr("House.arc")
  tell("renamed:", line(11))
  tell("renamed in House.arc:", line(8, house))

  vim.api.nvim_buf_set_lines(0, 6, 7, true, { "state   closed ;" })
  await("an edit to be read", function() return #findings() == 0 end)
  local format = vim.lsp.buf.format or vim.lsp.buf.formatting_sync
  format()
  await("the layout", function() return line(7) == "        state closed;" end)
  tell("formatted:", line(7))
end

local fine, reason = pcall(drive)
if not fine then
  tell("failed:", reason)
end
vim.fn.writefile(told, vim.env.TOLD)
vim.cmd("qall!")
