//// p/Bad.arc
package p;
component Bad<T> {
  port in int[] numbers, in String[][] tables, in java.util.Set<Integer>[] sets, out T[] any, in Mode [ ] modes;
//        ~~~~~ warning ARC0149: 'int[]' is read as 'java.util.List<Integer>': arrays are lists here; write that
//                          ~~~~~~~~~~ warning ARC0149: 'String[][]' is read as 'java.util.List<java.util.List<String>>': arrays are lists here; write that
//                                                ~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0149: 'java.util.Set<Integer>[]' is read as 'java.util.List<java.util.Set<Integer>>': arrays are lists here; write that
//                                                                                   ~~~ warning ARC0149: 'T[]' is read as 'java.util.List<T>': arrays are lists here; write that
//                                                                                               ~~~~~~~~ warning ARC0149: 'Mode [ ]' is read as 'java.util.List<Mode>': arrays are lists here; write that
}

//// p/Own.cd
package p;
classdiagram Own { enum Mode { on, off; } }

//// p/Good.arc
package p;
import java.util.List;
component Good {
  port in List<Integer> numbers, in int each[4];
}
