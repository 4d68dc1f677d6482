package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.ExpressionContext;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** One thing that an action does, in Arcomat's words. */
sealed interface Deed {
    /**
     * A statement that sends nothing.
     *
     * @param changed the variable that has another value afterwards, or is declared; empty for none
     * @param declares whether it is declared
     */
    record Said(String text, String changed, boolean declares) implements Deed {}

    /**
     * A message on a port.
     *
     * @param reads what the value is computed from, and may have another one later
     */
    record Sent(String port, String value, Set<String> reads) implements Deed {}

    record Choice(Condition condition, List<Deed> then, List<Deed> otherwise) implements Deed {}

    /** What is declared in it ends with it. */
    record Block(List<Deed> inside) implements Deed {}

    /**
     * What a choice asks.
     *
     * @param original how the original says it, where nothing but input ports decides
     */
    record Condition(String text, Optional<ExpressionContext> original) {}

    /** Whether they have names that are known to the end of the block. */
    static boolean declare(List<Deed> deeds) {
        return deeds.stream().anyMatch(each -> each instanceof Said said && said.declares());
    }

    /** Statements, one after the other. */
    static String text(List<Deed> deeds) {
        StringBuilder text = new StringBuilder();
        for (Deed each : deeds) {
            if (each instanceof Said said) {
                text.append(said.text()).append(";\n");
            } else if (each instanceof Sent sent) {
                text.append(sent.port()).append(" = ").append(sent.value()).append(";\n");
            } else if (each instanceof Block block) {
                text.append("{").append(text(block.inside())).append("}\n");
            } else if (each instanceof Choice choice) {
                text.append(text(choice)).append("\n");
            }
        }
        return text.toString();
    }

    private static String text(Choice choice) {
        String text = "if (" + choice.condition().text() + ") {" + text(choice.then()) + "}";
        if (choice.otherwise().isEmpty()) {
            return text;
        }
        return choice.otherwise().size() == 1 && choice.otherwise().get(0) instanceof Choice next
                ? text + " else " + text(next)
                : text + " else {" + text(choice.otherwise()) + "}";
    }
}
