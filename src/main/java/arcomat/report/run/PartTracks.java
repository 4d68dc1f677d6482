package arcomat.report.run;

import arcomat.model.Component;
import arcomat.model.Component.Composite;
import arcomat.model.Component.Part;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.report.page.Story.Drawing;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/** What the parts of a component send to each other in a run. Empty of one that does not tell. */
final class PartTracks {
    private final Trace trace;
    private final boolean told;
    private final WireSources wires;

    /** By their paths, as declared, each before its own parts; platform components are outside. */
    private final Map<String, Component> parts = new LinkedHashMap<>();

    /**
     * @param told whether the run tells what parts send, be it nothing
     */
    PartTracks(Trace trace, boolean told) {
        this.trace = trace;
        this.told = told;
        wires = new WireSources(trace.component());
        learn(trace.component(), "");
    }

    private void learn(Component component, String prefix) {
        if (!(component.body() instanceof Composite composite) || component.platform()) {
            return;
        }
        for (Part part : composite.parts()) {
            if (!part.component().platform()) {
                parts.put(prefix + part.name(), part.component());
                learn(part.component(), prefix + part.name() + ".");
            }
        }
    }

    List<String> paths() {
        return List.copyOf(parts.keySet());
    }

    /** What a part sends; what a composite sends, one of its own parts does. */
    List<Track> outputs(String part) {
        List<Track> tracks = new ArrayList<>();
        Component component = Objects.requireNonNull(parts.get(part));
        for (Port port : told ? component.outputs() : List.<Port>of()) {
            String name = part + "." + port.name();
            tracks.add(Track.of(Track.PART + part, name, Kind.PORT, texts(wires.sender(name))));
        }
        return tracks;
    }

    private Stream<String> texts(String sender) {
        List<Letter> received = trace.received();
        List<String> texts = new ArrayList<>();
        for (int step = 0; step < trace.shown().size(); step++) {
            Letter between =
                    step < trace.steps().size()
                            ? trace.steps().get(step).between()
                            : Letter.SILENCE;
            Letter from = between.messages(sender).isEmpty() ? received.get(step) : between;
            texts.add(TraceTable.text(from.messages(sender)));
        }
        return texts.stream();
    }

    /** The architecture, where there is one, with the rows that say what its ports carry. */
    Optional<Drawing> drawing(RunDrawings pictures) {
        return told ? Optional.of(pictures.parts(trace.component(), carried())) : Optional.empty();
    }

    /** The rows of ports: those of their senders, as far as these have a row of their own. */
    private Map<String, String> carried() {
        Map<String, String> rows = new LinkedHashMap<>();
        Component whole = trace.component();
        whole.ports().forEach(port -> rows.put(port.name(), port.name()));
        learn(rows, whole, "");
        return rows;
    }

    private void learn(Map<String, String> rows, Component component, String prefix) {
        if (!(component.body() instanceof Composite composite) || component.platform()) {
            return;
        }
        for (Part part : composite.parts()) {
            String path = prefix + part.name();
            for (Port port : part.component().ports()) {
                String name = path + "." + port.name();
                boolean outside = part.component().platform();
                rows.put(name, outside || !port.isInput() ? name : wires.sender(name));
            }
            learn(rows, part.component(), path + ".");
        }
    }
}
