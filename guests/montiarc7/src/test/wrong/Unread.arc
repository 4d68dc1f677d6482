component Unread {
  port in int;
}
