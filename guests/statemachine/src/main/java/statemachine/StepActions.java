package statemachine;

import arcomat.guest.Meaning;

import statemachine.Machine.Action;
import statemachine.Machine.Item;

import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What is done in one step, as one block. Actions follow one another, and those of an automaton are
 * all at once: of a variable the last value counts, a port has one message, and what was written is
 * not read again, so that the two are the same.
 */
final class StepActions {
    private final Set<String> variables;
    private final Meaning meaning;
    private final Set<String> told = new HashSet<>();

    StepActions(Set<String> variables, Meaning meaning) {
        this.variables = variables;
        this.meaning = meaning;
    }

    /**
     * @param actions in the order in which they are done
     */
    Collection<Item> together(List<Action> actions) {
        Map<String, Item> written = new LinkedHashMap<>();
        for (Action action : actions) {
            Map<String, Item> before = Map.copyOf(written);
            Set<String> here = new HashSet<>();
            for (Item item : action.items()) {
                item.reads().stream()
                        .filter(before::containsKey)
                        .sorted()
                        .forEach(name -> readBack(item, name, before.get(name)));
                String name = item.name().text();
                Item other = written.remove(name);
                if (other != null && (!variables.contains(name) || !here.add(name))) {
                    writtenTwice(item, other);
                }
                here.add(name);
                written.put(name, item);
            }
        }
        return written.values();
    }

    private void readBack(Item item, String name, Item before) {
        tellOnce(
                Mistake.READ_BACK,
                item,
                "'%s' is read here and gets a value in the same step, in line %d; say the value, or"
                        + " do both in one action",
                name,
                before);
    }

    private void writtenTwice(Item item, Item before) {
        tellOnce(
                Mistake.WRITTEN_TWICE,
                item,
                "'%s' gets a message here and, in the same step, in line %d; a step sends one",
                item.name().text(),
                before);
    }

    private void tellOnce(Mistake mistake, Item item, String message, String name, Item before) {
        int line = before.place().startPosition().line();
        if (told.add(mistake + " " + item.place() + " " + line)) {
            mistake.tell(meaning, item.place(), message, name, line);
        }
    }
}
