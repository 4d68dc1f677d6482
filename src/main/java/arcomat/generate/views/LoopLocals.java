package arcomat.generate.views;

import arcomat.generate.text.FileContext;
import arcomat.generate.view.CompositeView.LocalView;
import arcomat.model.Component;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What a loop over an array of parts calls the elements that one round works on. They are locals,
 * not written as {@code cells[i]} each time, since that form was seen to make a chain of 1,000
 * parts twice as slow in about every second virtual machine: when messages are missing now and
 * then, the branches on them are foreseen or not, as the compiler happens to lay them out. Handing
 * the element of one round on to the next is slow always.
 */
final class LoopLocals {
    private final FileContext context;
    private final boolean loops;
    private final Map<String, LocalView> byPlace = new LinkedHashMap<>();

    /**
     * @param loops whether there is a loop; what is written for one element names it by its place
     */
    LoopLocals(FileContext context, boolean loops) {
        this.context = context;
        this.loops = loops;
    }

    /** The part that gets messages and takes its step. */
    String receiver(Component component, String place) {
        return name(component, place, "receiver");
    }

    String sender(Component component, String place) {
        long senders = byPlace.values().stream().skip(1).count();
        return name(component, place, senders == 0 ? "sender" : "sender" + (senders + 1));
    }

    private String name(Component component, String place, String word) {
        return loops
                ? byPlace.computeIfAbsent(place, here -> local(component, here, word)).name()
                : place;
    }

    private LocalView local(Component component, String place, String word) {
        String type = context.references().to(context.names().of(component));
        return new LocalView(type, context.members().local(word), place);
    }

    /** In the order of their declarations: the receiver, then those who send to it. */
    List<LocalView> all() {
        return new ArrayList<>(byPlace.values());
    }

    /** The receiver alone; none where there is no loop. */
    List<LocalView> receivers() {
        return all().subList(0, Math.min(1, byPlace.size()));
    }
}
