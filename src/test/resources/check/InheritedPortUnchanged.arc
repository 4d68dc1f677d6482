//// p/Motor.arc
package p;
component Motor {
  port in Integer power, out Integer turns, in Boolean brake;
}

//// p/Bad.arc
package p;
component Bad extends Motor {
  port in Boolean power, in Integer turns, in Boolean brake;
//                ~~~~~ error ARC0114: port 'power' is inherited as 'in Integer', but declared as 'in Boolean'; give this one another name
//                                  ~~~~~ error ARC0114: port 'turns' is inherited as 'out Integer', but declared as 'in Integer'; give this one another name
}

//// p/Buffer.arc
package p;
component Buffer<T> {
  port in T i, out T o;
}

//// p/BadBuffer.arc
package p;
component BadBuffer extends Buffer<Integer> {
  port in Boolean i, out Integer o;
//                ~ error ARC0114: port 'i' is inherited as 'in Integer', but declared as 'in Boolean'; give this one another name
}

//// p/Good.arc
package p;
component Good extends Motor {
  port in Integer power, in Boolean boost;
}
