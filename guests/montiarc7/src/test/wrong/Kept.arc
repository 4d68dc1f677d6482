component Kept {
  port sync in int a, sync out Book b;
  compute { Book book = Book.Book(); book.open(); b = book; }
}
