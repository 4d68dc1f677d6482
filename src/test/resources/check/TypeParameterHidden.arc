//// Bad.arc
component Bad<T, S> {
  component Inner<U, T> part<S, S> {
//                   ~ warning ARC0218: type parameter 'T' hides the one of 'Bad' around it; rename one of them
    component Deep<S> core<U> {
//                 ~ warning ARC0218: type parameter 'S' hides the one of 'Bad' around it; rename one of them
    }
  }
}

//// Good.arc
component Good<T> {
  component Inner<U> part<T> {
  }
  component Other<U> more<T> {
  }
}
