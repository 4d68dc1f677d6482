package arcomat.campaign;

import arcomat.campaign.JointWatch.Binding;
import arcomat.source.Diagnostic;
import arcomat.source.Span;
import arcomat.world.Word;
import arcomat.world.Words;
import arcomat.world.Words.Unreadable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A watch on several robots while it is read: a line for each port, up to the closing brace. */
final class WatchBlock {
    private static final String OPENED = "{";
    private static final String CLOSED = "}";

    private final String name;
    private final Span requirement;
    private final Map<String, Binding> bindings = new LinkedHashMap<>();

    private WatchBlock(String name, Span requirement) {
        this.name = name;
        this.requirement = requirement;
    }

    /** Whether what stands behind the name of a watch opens a block. */
    static boolean isOpened(Watched watched) {
        return watched.requirement().endsWith(OPENED);
    }

    static WatchBlock of(Watched watched, Words words) throws Unreadable {
        String text = watched.requirement();
        String named = text.substring(0, text.length() - OPENED.length()).stripTrailing();
        Span place = watched.place();
        Span requirement = place.file().span(place.start(), place.start() + named.length());
        if (named.isEmpty()) {
            throw words.wrong(place, "here should stand a requirement of the models");
        }
        return new WatchBlock(watched.name(), requirement);
    }

    /** Whether a line ends it. */
    static boolean isClosedBy(Words words) {
        return words.take(CLOSED);
    }

    Span place() {
        return requirement;
    }

    /** {@code PORT = WHAT}. */
    void read(Words words) throws Unreadable {
        Word port = words.next("the name of a port");
        if (!words.take("=")) {
            throw words.wrong(port, "here should stand 'PORT = WHAT', or '}' behind the last one");
        }
        Span source = words.rest("a port of a robot, or an expression");
        Binding binding = new Binding(port.text(), source, port.place());
        Binding before = bindings.putIfAbsent(port.text(), binding);
        if (before != null) {
            throw new Unreadable(
                    Diagnostic.error(
                                    CampaignParser.TWICE,
                                    port.place(),
                                    "'%s' is bound twice".formatted(port.text()))
                            .withRelated(before.place(), "the first one"));
        }
    }

    JointWatch watch() {
        List<Binding> all = new ArrayList<>(bindings.values());
        return new JointWatch(name, requirement.text(), all, requirement);
    }
}
