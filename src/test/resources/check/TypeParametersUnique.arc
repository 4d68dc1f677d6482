//// BadPair.arc
component BadPair<T, U, T> {
//                      ~ error ARC0202: component 'BadPair' has a type parameter 'T' already; rename one of them
  port in T first, in U second;
}

//// GoodPair.arc
component GoodPair<T, U> {
  port in T first, in U second;
}
