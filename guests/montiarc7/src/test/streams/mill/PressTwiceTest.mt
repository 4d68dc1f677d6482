package mill;

testsuite PressTwiceTest for PressHall(careful = false, twice = true) {
  test isSlowOnlyOnce {
    input {
      weight: <3, Tk, 12, Tk, Tk>;
    }
    expect {
      pressed: <0, Tk, 3, Tk, 5, Tk>;
    }
  }
}
