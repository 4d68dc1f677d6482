// SYNTAX TEST "source.arcomat" "components: ports, parts, connectors, settings, automata, tables"
package coffee.fig6;
// <------- keyword.other.header.arcomat
//      ^^^^^^ entity.name.namespace.arcomat
import coffee.types.Types.*;
// <------ keyword.other.header.arcomat
//                        ^ constant.language.wildcard.arcomat

/** A door. */
// <----------- comment.block.documentation.arcomat
<<deploy, layer = "logic">> abstract deploy component Door<T extends Number>(Integer[0..9] x = 3)
// <-- punctuation.definition.stereotype.arcomat
//^^^^^^ entity.other.attribute-name.arcomat
//                ^^^^^^^ string.quoted.double.arcomat
//                          ^^^^^^^^ storage.modifier.arcomat
//                                   ^^^^^^ storage.modifier.arcomat
//                                          ^^^^^^^^^ storage.type.component.arcomat
//                                                    ^^^^ entity.name.type.component.arcomat
//                                                           ^^^^^^^ storage.modifier.arcomat
//                                                                                             ^ constant.numeric.arcomat
        extends Base refines p.Old, p.Older {
//      ^^^^^^^ storage.modifier.arcomat
//                   ^^^^^^^ storage.modifier.arcomat
    port in Boolean pressed, <<total>> in p.Types.Cmd state,
//  ^^^^ storage.type.port.arcomat
//       ^^ storage.modifier.direction.arcomat
//          ^^^^^^^ entity.name.type.arcomat
//                  ^^^^^^^ variable.other.port.arcomat
//                             ^^^^^ entity.other.attribute-name.arcomat
//                                     ^^ storage.modifier.direction.arcomat
//                                        ^ entity.name.namespace.arcomat
//                                                    ^^^^^ variable.other.port.arcomat - storage.type.state.arcomat
        out int[0..5] out;
//      ^^^ storage.modifier.direction.arcomat
//          ^^^ storage.type.primitive.arcomat
//              ^ constant.numeric.arcomat
//               ^^ keyword.operator.range.arcomat
//                    ^^^ variable.other.port.arcomat - storage.modifier.direction.arcomat
    ports in Boolean a;
//  ^^^^^ storage.type.port.arcomat

    timing delayed;
//  ^^^^^^ keyword.other.setting.arcomat
//         ^^^^^^^ constant.language.setting.arcomat
    behavior sync;
//  ^^^^^^^^ keyword.other.setting.arcomat
    autoconnect port;
//  ^^^^^^^^^^^ keyword.other.setting.arcomat
//              ^^^^ constant.language.setting.arcomat - storage.type.port.arcomat
    autoinstantiate off;
//  ^^^^^^^^^^^^^^^ keyword.other.setting.arcomat
//                  ^^^ constant.language.setting.arcomat
    feature dimmer, alarm;
//  ^^^^^^^ keyword.other.setting.arcomat
    constraint (alarm implies dimmer);
//  ^^^^^^^^^^ keyword.other.setting.arcomat
    varif (dimmer) {
//  ^^^^^ keyword.other.setting.arcomat
    }

    component Motor(2, true) left, right;
//  ^^^^^^^^^ storage.type.component.arcomat
//            ^^^^^ entity.name.type.component.arcomat
//                  ^ constant.numeric.arcomat
//                     ^^^^ constant.language.arcomat
    connect left.turned -> right.speed, out;
//  ^^^^^^^ keyword.control.connect.arcomat
//          ^^^^ variable.other.port.arcomat
//                      ^^ keyword.operator.arrow.arcomat
//                                      ^^^ variable.other.port.arcomat

    ocl inv safe: a implies b;
//      ^^^ keyword.other.invariant.arcomat
//          ^^^^ entity.name.function.invariant.arcomat
//                  ^^^^^^^ keyword.operator.word.arcomat
    compute once { x = 1; }
//  ^^^^^^^ storage.type.behaviour.arcomat
//          ^^^^ entity.name.function.arcomat
    init { }
//  ^^^^ storage.type.behaviour.arcomat
    implementation Fast {
//  ^^^^^^^^^^^^^^ storage.type.behaviour.arcomat
//                 ^^^^ entity.name.function.arcomat
    }
    var Integer count = 0;
//  ^^^ storage.type.variable.arcomat

    <<completion = "ignore">> automaton Opening {
//                            ^^^^^^^^^ storage.type.automaton.arcomat
//                                      ^^^^^^^ entity.name.type.automaton.arcomat
        state closed, <<error>> open;
//      ^^^^^ storage.type.state.arcomat
//            ^^^^^^ variable.other.constant.state.arcomat
//                      ^^^^^ entity.other.attribute-name.arcomat
//                              ^^^^ variable.other.constant.state.arcomat
        initial closed, open / {cmd = fwd};
//      ^^^^^^^ keyword.control.initial.arcomat
//              ^^^^^^ variable.other.constant.state.arcomat
//                              ^^^ variable.other.port.arcomat
        input Boolean seen;
//      ^^^^^ storage.type.variable.arcomat
        output Boolean told;
//      ^^^^^^ storage.type.variable.arcomat
        variable Integer n;
//      ^^^^^^^^ storage.type.variable.arcomat
        closed -> open [n > 3 && !seen] {pressed == true} / {told = --, call n.next()};
//      ^^^^^^ variable.other.constant.state.arcomat
//             ^^ keyword.operator.arrow.arcomat
//                ^^^^ variable.other.constant.state.arcomat
//                        ^ keyword.operator.comparison.arcomat
//                            ^^ keyword.operator.logical.arcomat
//                               ^ keyword.operator.logical.arcomat
//                                       ^^^^^^^ variable.other.port.arcomat
//                                               ^^ keyword.operator.comparison.arcomat
//                                                           ^^^^ variable.other.port.arcomat
//                                                                  ^^ constant.language.absence.arcomat
//                                                                      ^^^^ keyword.control.call.arcomat
        state -> initial [if a then b else c] / {out = alt{1, 2}, n++};
//      ^^^^^ variable.other.constant.state.arcomat - storage.type.state.arcomat
//               ^^^^^^^ variable.other.constant.state.arcomat - keyword.control.initial.arcomat
//                        ^^ keyword.control.arcomat
//                             ^^^^ keyword.control.arcomat
//                                    ^^^^ keyword.control.arcomat
//                                                     ^^^ keyword.control.alternatives.arcomat
//                                                                 ^^ keyword.operator.arithmetic.arcomat
        closed [x instanceof Old || y isin {1} <=> new Old() == null];
//      ^^^^^^ variable.other.constant.state.arcomat
//                ^^^^^^^^^^ keyword.operator.word.arcomat
//                                    ^^^^ keyword.operator.word.arcomat
//                                          ^ constant.numeric.arcomat
//                                             ^^^ keyword.operator.logical.arcomat
//                                                 ^^^ keyword.operator.new.arcomat
//                                                              ^^^^ constant.language.arcomat
    }

    table {
//  ^^^^^ storage.type.table.arcomat
        in pressed, state;
//      ^^ storage.modifier.direction.arcomat
        out cmd;
//      ^^^ storage.modifier.direction.arcomat
        | true | * | => | fwd |;
//      ^ punctuation.separator.cell.arcomat
//        ^^^^ constant.language.arcomat
//                   ^^ keyword.operator.arrow.arcomat
    }
}
// A line. ^^^
// <---------- comment.line.double-slash.arcomat
