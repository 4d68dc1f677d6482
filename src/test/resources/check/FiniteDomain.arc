//// T.cd
classdiagram T {
  enum Light { red, green }
  class Cup { int volume; }
}

//// Bad.arc
import T.*;
component Bad {
  port in Integer n, in Light light, in Boolean go[2], out Integer count;

  automaton {
    state s;
    initial s;
    s [forall i in {0..n}: i > 0] / {count = 1};
//                  ~~~~ error ARC0347: the ends of a range are two whole numbers or two characters that are known before the run
    s [exists i in Integer: i > n] / {count = 1};
//                 ~~~~~~~ error ARC0347: this stands for more than 1,000 conditions; say it of fewer values, or keep part of it in a variable
    s [exists c in Cup: c.volume > n] / {count = 1};
//                 ~~~ error ARC0347: 'Cup' is no finite set; name an enumeration, a range or an array
    s [exists c in nobody: c > n] / {count = 1};
//                 ~~~~~~ error ARC0329: there is no array and no type 'nobody'
    s [go[n]] / {count = 1};
//        ~ error ARC0347: 'n' is no whole number that is known before the run; number the elements of 'go' from 0
    s [go[2]] / {count = 1};
//     ~~~~~ error ARC0329: 'go[2]' is not a port, a variable or a parameter; the array has go[0] to go[1]
    s [go] / {count = 1};
//     ~~ error ARC0329: 'go' is not a port, a variable or a parameter; it is an array, name one of go[0] to go[1]
    s [forall a in {1..40}: forall b in {1..40}: a + b > n] / {count = 1};
//                          ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0347: this stands for more than 1,000 conditions; say it of fewer values, or keep part of it in a variable
    s [exists c in Light: n] / {count = 1};
//            ~ error ARC0346: 'c' is not used; leave it out
//                        ~ error ARC0330: what is said of each is Boolean, but 'n' has type Integer
  }
}

//// Good.arc
import T.*;
component Good {
  port in Integer n, in char key, in Light light, in Boolean go[2], out Integer count;

  automaton {
    state s;
    initial s;
    s [forall i in Set {0..3, 7}: i != n] / {count = 1};
    s [exists c in Light: light == c && c != red] / {count = 2};
    s [exists c in {'a'..'f', 'x'}: key == c] / {count = 3};
    s [forall b in boolean: exists g in go: g == b] / {count = 4};
    s [forall d in Integer[-1..1]: n != d] / {count = 5};
    s [forall d in {}: n != d] / {count = 6};
    s [let i = n + 1 in let j = i * i in go[0] && j > i] / {count = 7};
  }
}
