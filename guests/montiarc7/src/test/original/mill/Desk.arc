package mill;

/** Writes into books, which nobody reads here. */
component Desk {
  port sync in int number, sync out int copy;

  automaton {
    initial state Open;
    Open -> Open / {
      Book book = Book.Book(number);
      book.open();
      int pages = book.pages;
      pages = book.pages + 1;
      book.pages = pages;
      Book.last = book;
      mill.Signals.Switch.reset();
      Shelf.Shelf().add(book, number);
      copy = number;
    }
  }
}
