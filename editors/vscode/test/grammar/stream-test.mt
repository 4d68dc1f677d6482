// SYNTAX TEST "source.arcomat.stream-test" "suites, tests and streams"
package shop;
testsuite StopTest for coffee.fig6.AvoidCrash(3) {
// <--------- storage.type.test-suite.arcomat
//        ^^^^^^^^ entity.name.type.test-suite.arcomat
//                 ^^^ keyword.other.for.arcomat
//                     ^^^^^^^^^^^^^^^^^^^^^^ entity.name.type.component.arcomat
    Integer far = 3;
//  ^^^^^^^ entity.name.type.arcomat
    @Before { }
//  ^^^^^^^ storage.type.annotation.arcomat
    test stops {
//  ^^^^ storage.type.test.arcomat
//       ^^^^^ entity.name.function.test.arcomat
        input {
//      ^^^^^ keyword.control.streams.arcomat
            front.us: <clear, 2*Tk, -3, 3*(true, Tk)>;
//          ^^^^^^^^ variable.other.port.arcomat
//                  ^ punctuation.separator.stream.arcomat
//                            ^ constant.numeric.arcomat
//                              ^^ constant.language.tick.arcomat
//                                         ^^^^ constant.language.arcomat
            test: <true>;
//          ^^^^ variable.other.port.arcomat - storage.type.test.arcomat
        }
        expect {
//      ^^^^^^ keyword.control.streams.arcomat
            input: <fwd>;
//          ^^^^^ variable.other.port.arcomat - keyword.control.streams.arcomat
        }
        events {
//      ^^^^^^ keyword.control.streams.arcomat
            a: fwd;
//          ^ variable.other.port.arcomat
        }
    }
}
