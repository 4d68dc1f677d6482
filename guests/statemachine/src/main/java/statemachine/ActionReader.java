package statemachine;

import statemachine.Machine.Action;
import statemachine.Machine.Item;
import statemachine.Machine.Label;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Reads what is done: messages and assignments, each with the name of what gets the value. */
record ActionReader(TokenCursor cursor) {
    private static final List<String> ENDS = List.of(",", ";", "}");

    Action read() throws UnreadableText {
        cursor.expect("{");
        List<Item> items = new ArrayList<>();
        while (!cursor.isAt("}")) {
            items.add(item());
            if (!cursor.isAt("}")) {
                cursor.next();
            }
        }
        cursor.expect("}");
        return new Action(items);
    }

    private Item item() throws UnreadableText {
        Token first = cursor.peek();
        List<Token> tokens = cursor.upTo(ENDS);
        if (tokens.isEmpty()) {
            throw cursor.unexpected("'name = value'");
        }
        if (tokens.size() < 3 || !first.isWord() || !tokens.get(1).is("=")) {
            throw new UnreadableText(
                    Mistake.NO_ASSIGNMENT,
                    cursor.since(first),
                    "say what gets the value, as in 'cmd = stop': an action is put together with"
                            + " others");
        }
        Label name = new Label(cursor.place(first), first.text());
        return new Item(cursor.since(first), name, reads(tokens));
    }

    /** The names in a value: not what stands behind a dot, which is part of something. */
    private static Set<String> reads(List<Token> item) {
        Set<String> names = new LinkedHashSet<>();
        for (int i = 2; i < item.size(); i++) {
            if (item.get(i).isWord() && !item.get(i - 1).is(".")) {
                names.add(item.get(i).text());
            }
        }
        return names;
    }
}
