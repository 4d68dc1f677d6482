package arcomat.editor.answer.completion;

import arcomat.syntax.Continuations;

import java.util.List;

/**
 * A piece of a model to be filled in.
 *
 * @param word the keyword it begins with, or, where it begins with a name, one that may stand in
 *     its place
 * @param label by which it is chosen
 * @param detail what it is
 * @param text with places to fill in, as the protocol writes them
 */
public record Skeleton(String word, String label, String detail, String text) {
    static final List<Skeleton> ALL =
            List.of(
                    new Skeleton(
                            "autoconnect",
                            "component ... {}",
                            "a component inside of this one",
                            """
                            component ${1:Name} {
                                port in ${2:Boolean} ${3:input},
                                     out ${4:Boolean} ${5:output};

                                $0
                            }\
                            """),
                    new Skeleton(
                            "automaton",
                            "automaton {}",
                            "behaviour by states and transitions",
                            """
                            automaton {
                                state ${1:idle};
                                initial ${1:idle};

                                $0
                            }\
                            """),
                    new Skeleton(
                            "initial",
                            "transition",
                            "from state to state",
                            "${1:source} -> ${2:target} [${3:guard}] {${4:inputs}} /"
                                    + " {${5:outputs}};$0"),
                    new Skeleton(
                            "test",
                            "test ... {}",
                            "inputs and the outputs that are expected",
                            """
                            test ${1:name} {
                                input {
                                    ${2:port}: <$3>;
                                }
                                expect {
                                    ${4:port}: <$5>;
                                }
                            }$0\
                            """));

    boolean fits(Continuations possible) {
        return possible.words().contains(word);
    }
}
