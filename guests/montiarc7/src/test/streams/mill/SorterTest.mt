package mill;

testsuite SorterTest for Sorter {
  test choosesAndBeginsAnew {
    input {
      kind: <"cork", Tk, "iron", Tk, "iron", Tk, "iron", Tk, "clay", Tk, "clay", Tk>;
      size: <11, Tk, 12, Tk, 0, Tk, 11, Tk, 0, Tk, 11, Tk>;
    }
    expect {
      box: <1, Tk, 7, Tk, 0, Tk, 2, Tk, 0, Tk, 4, Tk>;
    }
  }
}
