//// bad.arc
component bad<t> {
//        ~~~ warning ARC0209: component 'bad' should start with a capital letter; rename it
//            ~ warning ARC0209
  port in t i, out Boolean o;
}

//// Types.cd
classdiagram Types {
  enum signal { alert; }
//     ~~~~~~ warning ARC0209: type 'signal' should start with a capital letter; rename it
}

//// Good.arc
component Good<T> {
  port in T i, out Boolean o;
}
