component Asked {
  port sync in int a, sync out int b;
  compute { Book book = Book.Book(); if (book.pages > 3) { b = a; } }
}
