testsuite T for X {
  tst a {
    input { a: <true>; }
  }
  test b {
    expct { a: <true>; }
  }
}
