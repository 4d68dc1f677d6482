//// BadFetcher.arc
component BadFetcher fetcher {
//                   ~~~~~~~ error ARC0101: top-level component 'BadFetcher' cannot have the instance name 'fetcher'; delete it
  port in Boolean i, out Boolean o;
}

//// GoodFetcher.arc
component GoodFetcher {
  port in Boolean i, out Boolean o;

  component Inner inner {
    port in Boolean i, out Boolean o;
  }

  connect i -> inner.i;
  connect inner.o -> o;
}
