package a;
// x
