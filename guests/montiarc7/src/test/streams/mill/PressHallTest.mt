package mill;

testsuite PressHallTest for PressHall(careful = true, twice = false) {
  test sendsOneSliceLater {
    input {
      weight: <3, Tk, 12, Tk, Tk>;
    }
    expect {
      pressed: <0, Tk, 3, Tk, 9, Tk>;
    }
  }
}
