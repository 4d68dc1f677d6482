package statemachine;

import arcomat.guest.BehaviourLanguage.Written;
import arcomat.source.Span;

import statemachine.Machine.Action;
import statemachine.Machine.Beginning;
import statemachine.Machine.During;
import statemachine.Machine.Label;
import statemachine.Machine.Memory;
import statemachine.Machine.Priority;
import statemachine.Machine.State;
import statemachine.Machine.Target;
import statemachine.Machine.Transition;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Reads a state machine by recursive descent. Guards and input blocks are Arcomat's own. */
final class MachineReader {
    /** States in states in states: what is deeper is nobody's picture of anything. */
    private static final int DEEPEST = 40;

    private static final Set<String> WORDS =
            Set.of("state", "initial", "entry", "exit", "do", "variable", "var", "priority");

    private final TokenCursor cursor;
    private final List<Span> declarations = new ArrayList<>();
    private final Set<String> variables = new LinkedHashSet<>();
    private Priority priority = Priority.OPEN;

    private MachineReader(TokenCursor cursor) {
        this.cursor = cursor;
    }

    static Machine read(Written behaviour) throws UnreadableText {
        MachineReader reader = new MachineReader(new TokenCursor(behaviour));
        State root = reader.body(new Label(behaviour.keyword(), ""), 0);
        return new Machine(reader.declarations, reader.variables, reader.priority, root);
    }

    /** What stands in the braces of a state, or of the machine. */
    private State body(Label name, int depth) throws UnreadableText {
        if (depth > DEEPEST) {
            throw new UnreadableText(name.place(), "states are nested too deeply; 40 is the most");
        }
        StateParts parts = new StateParts();
        while (!cursor.isAt("}") && !cursor.isAtEnd()) {
            element(parts, depth);
        }
        return parts.state(name);
    }

    private void element(StateParts parts, int depth) throws UnreadableText {
        Token first = cursor.peek();
        switch (first.text()) {
            case "state" -> states(parts, depth);
            case "initial" -> parts.add(initial());
            case "entry", "exit" -> {
                inside(depth, first);
                cursor.next();
                cursor.expect("/");
                Action action = new ActionReader(cursor).read();
                cursor.expect(";");
                parts.add(first.text().equals("entry"), cursor.place(first), action);
            }
            case "do" -> {
                inside(depth, first);
                cursor.next();
                cursor.expect("/");
                Action action = new ActionReader(cursor).read();
                cursor.expect(";");
                parts.add(new During(cursor.since(first), action));
            }
            case "priority" -> priority(depth);
            case "variable", "var" -> variables(depth);
            default -> parts.add(transition());
        }
    }

    /** The machine as a whole is neither entered nor left. */
    private void inside(int depth, Token word) throws UnreadableText {
        if (depth == 0) {
            throw new UnreadableText(
                    cursor.place(word),
                    "'%s' belongs into a state: the machine as a whole is never entered or left"
                            .formatted(word.text()));
        }
    }

    private void states(StateParts parts, int depth) throws UnreadableText {
        cursor.next();
        Label name = stateName();
        if (cursor.isAt("{")) {
            cursor.next();
            parts.add(body(name, depth + 1));
            cursor.expect("}");
            return;
        }
        parts.add(new StateParts().state(name));
        while (cursor.isAt(",")) {
            cursor.next();
            parts.add(new StateParts().state(stateName()));
        }
        cursor.expect(";");
    }

    private Label stateName() throws UnreadableText {
        Label name = cursor.name("the name of a state");
        if (WORDS.contains(name.text())) {
            throw new UnreadableText(
                    name.place(),
                    "'%s' is a word of state machines; give the state another name"
                            .formatted(name.text()));
        }
        return name;
    }

    private Beginning initial() throws UnreadableText {
        Token first = cursor.next();
        Label state = cursor.name("the state to begin with");
        Optional<Action> action = effect();
        cursor.expect(";");
        return new Beginning(cursor.since(first), state, action);
    }

    private Optional<Action> effect() throws UnreadableText {
        if (!cursor.isAt("/")) {
            return Optional.empty();
        }
        cursor.next();
        return Optional.of(new ActionReader(cursor).read());
    }

    private void priority(int depth) throws UnreadableText {
        Token first = cursor.next();
        if (depth > 0 || priority != Priority.OPEN) {
            throw new UnreadableText(
                    Mistake.SAID_TWICE,
                    cursor.place(first),
                    "who comes first is said once, outside of all states");
        }
        Label who = cursor.name("'inner' or 'outer'");
        priority =
                switch (who.text()) {
                    case "inner" -> Priority.INNER;
                    case "outer" -> Priority.OUTER;
                    default ->
                            throw new UnreadableText(
                                    who.place(),
                                    "'inner' transitions come first or 'outer' ones, not '%s'"
                                            .formatted(who.text()));
                };
        cursor.expect(";");
    }

    private Transition transition() throws UnreadableText {
        Token first = cursor.peek();
        Label source = cursor.name("a state, a transition, 'initial', 'entry', 'exit' or 'do'");
        Optional<Target> target = Optional.empty();
        if (cursor.isAt("->")) {
            cursor.next();
            target = Optional.of(target());
        }
        Optional<Span> guard = cursor.balanced("[", "]");
        Optional<Span> input = cursor.balanced("{", "}");
        Optional<Action> output = effect();
        cursor.expect(";");
        return new Transition(cursor.since(first), source, target, guard, input, output);
    }

    private Target target() throws UnreadableText {
        Label state = cursor.name("the state that it leads to");
        if (!cursor.isAt(".")) {
            return new Target(state, Memory.NONE);
        }
        cursor.next();
        Label memory = cursor.name("'history' or 'deepHistory'");
        return switch (memory.text()) {
            case "history" -> new Target(state, Memory.SHALLOW);
            case "deepHistory" -> new Target(state, Memory.DEEP);
            default ->
                    throw new UnreadableText(
                            memory.place(),
                            "a state goes on with '.history' or with '.deepHistory', not with '.%s'"
                                    .formatted(memory.text()));
        };
    }

    /** Names are where a value, a comma or the end follows; all else is Arcomat's. */
    private void variables(int depth) throws UnreadableText {
        Token first = cursor.next();
        if (depth > 0) {
            throw new UnreadableText(
                    cursor.place(first),
                    "variables are those of the machine; declare them outside of its states");
        }
        Token last = first;
        boolean beforeValue = true;
        while (!cursor.isAt(";") && !cursor.isAtEnd()) {
            if (cursor.balanced("[", "]").isEmpty()
                    && cursor.balanced("(", ")").isEmpty()
                    && cursor.balanced("{", "}").isEmpty()) {
                Token next = cursor.next();
                if (beforeValue && last.isWord() && Set.of("=", ",").contains(next.text())) {
                    variables.add(last.text());
                }
                beforeValue = next.is(",") || beforeValue && !next.is("=");
                last = next;
            }
        }
        if (beforeValue && last.isWord()) {
            variables.add(last.text());
        }
        cursor.expect(";");
        declarations.add(cursor.since(first));
    }
}
