package arcomat.analysis.map;

import arcomat.analysis.map.BridgeSide.Offer;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.model.Component;
import arcomat.model.Component.Endpoint;
import arcomat.model.Component.Part;
import arcomat.model.Port;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Two components with different ports as two with the same: both read what the concrete one reads,
 * and send what the abstract one sends. What the concrete one sends goes through the map of
 * outputs, what the abstract one reads comes through that of inputs.
 */
final class Bridge {
    private static final String INPUTS = "inputs";
    private static final String OUTPUTS = "outputs";

    private final InterfaceMap map;
    private final BridgeSide left;
    private final BridgeSide right;
    private final List<Sentence> problems = new ArrayList<>();

    private Bridge(Promise concrete, Promise wanted, InterfaceMap map) {
        this.map = map;
        this.left = new BridgeSide(concrete);
        this.right = new BridgeSide(wanted);
    }

    /**
     * Both sides.
     *
     * @param problems why the map does not fit; where there are some, the sides are not to be used
     */
    record Sides(Promise left, Promise right, List<Sentence> problems) {}

    static Sides between(Promise concrete, Promise wanted, InterfaceMap map) {
        return new Bridge(concrete, wanted, map).sides();
    }

    private Sides sides() {
        List<Offer> read = left.component().inputs().stream().map(BridgeSide::outside).toList();
        for (Offer each : read) {
            left.connect(each.endpoint(), left.endpoint(each.port()));
        }
        List<Offer> sent = left.component().outputs().stream().map(left::offer).toList();
        List<Offer> all = Stream.concat(sent.stream(), read.stream()).toList();
        List<Offer> mappedInputs = mapped(right, INPUTS, map.inputs(), read);
        List<Offer> mappedOutputs = mapped(left, OUTPUTS, map.outputs(), all);
        requireKnown(mappedInputs, right.component().inputs(), "input");
        requireKnown(mappedOutputs, right.component().outputs(), "output");
        for (Port input : right.component().inputs()) {
            find(input, mappedInputs, read, "input")
                    .ifPresent(from -> right.connect(from.endpoint(), right.endpoint(input)));
        }
        List<Port> leftPorts = new ArrayList<>(left.component().inputs());
        List<Port> rightPorts = new ArrayList<>(leftPorts);
        for (Port output : right.component().outputs()) {
            String shown = shown(output);
            rightPorts.add(output.named(shown));
            Endpoint seen = new Endpoint(Optional.empty(), shown);
            right.connect(right.endpoint(output), seen);
            Optional<Offer> from = find(output, mappedOutputs, sent, "output");
            from.ifPresent(offer -> left.connect(offer.endpoint(), seen));
            from.ifPresent(offer -> leftPorts.add(offer.port().named(shown)));
        }
        return new Sides(left.whole(leftPorts), right.whole(rightPorts), List.copyOf(problems));
    }

    /** A component has one port of a name. */
    private String shown(Port output) {
        return left.component().port(output.name()).filter(Port::isInput).isPresent()
                ? InterfaceMap.longName(output, right.component())
                : output.name();
    }

    /** Puts a half of the map beside a side; what it sends, if there is one. */
    private List<Offer> mapped(
            BridgeSide side, String name, Optional<Promise> half, List<Offer> offers) {
        if (half.isEmpty()) {
            return List.of();
        }
        Part part = side.add(name, half.get());
        for (Port input : part.component().inputs()) {
            List<Offer> meant =
                    offers.stream()
                            .filter(each -> stands(input, each.port(), left.component()))
                            .toList();
            if (meant.isEmpty()) {
                problem(
                        input,
                        "the map %s reads '%s', which %s does not have",
                        map.title(),
                        input.name(),
                        left.title());
            }
            requireOneMeaning(input, meant.stream().map(Offer::port).toList(), left);
            meant.stream()
                    .findFirst()
                    .filter(each -> fits(each.port(), input))
                    .ifPresent(
                            each ->
                                    side.connect(
                                            each.endpoint(), BridgeSide.endpoint(part, input)));
        }
        return part.component().outputs().stream()
                .map(each -> BridgeSide.offer(part, each))
                .toList();
    }

    private static boolean stands(Port mapped, Port port, Component owner) {
        return mapped.name().equals(port.name())
                || mapped.name().equals(InterfaceMap.longName(port, owner));
    }

    private void requireKnown(List<Offer> mapped, List<Port> ports, String kind) {
        for (Offer each : mapped) {
            List<Port> meant =
                    ports.stream()
                            .filter(port -> stands(each.port(), port, right.component()))
                            .toList();
            requireOneMeaning(each.port(), meant, right);
            if (meant.isEmpty()) {
                problem(
                        each.port(),
                        "the map %s sends '%s', and %s has no such %s",
                        map.title(),
                        each.port().name(),
                        right.title(),
                        kind);
            }
        }
    }

    /** A long name of one port may be the name of another: nobody guesses which is meant. */
    private void requireOneMeaning(Port mapped, List<Port> meant, BridgeSide side) {
        if (meant.size() > 1) {
            problem(
                    mapped,
                    "'%s' of the map %s may stand for '%s' and for '%s' of %s: rename one",
                    mapped.name(),
                    map.title(),
                    meant.get(0).name(),
                    meant.get(1).name(),
                    side.title());
        }
    }

    /** What stands for a port of the abstract component: what the map says, else its namesake. */
    private Optional<Offer> find(Port port, List<Offer> mapped, List<Offer> own, String kind) {
        List<Offer> said =
                mapped.stream()
                        .filter(each -> stands(each.port(), port, right.component()))
                        .toList();
        if (said.size() > 1) {
            problem(
                    said.get(1).port(),
                    "the map %s sends '%s' and '%s', and both stand for %s '%s' of %s",
                    map.title(),
                    said.get(0).port().name(),
                    said.get(1).port().name(),
                    kind,
                    port.name(),
                    right.title());
        }
        Optional<Offer> found =
                Stream.concat(
                                said.stream(),
                                own.stream().filter(each -> each.port().name().equals(port.name())))
                        .findFirst();
        if (found.isEmpty()) {
            problem(
                    port,
                    "nothing stands for %s '%s' of %s: the map %s does not send it, and %s has no"
                            + " %s of that name",
                    kind,
                    port.name(),
                    right.title(),
                    map.title(),
                    left.title(),
                    kind);
        }
        return found.filter(offer -> fits(offer.port(), port));
    }

    /** Whether what one port sends can be read, or shown, by another. */
    private boolean fits(Port from, Port to) {
        if (!from.type().equals(to.type())) {
            problem(
                    from,
                    "'%s' carries %s and stands for '%s', which carries %s",
                    from.name(),
                    from.type().name(),
                    to.name(),
                    to.type().name());
            return false;
        }
        if (to.isInput() && to.total() && !from.total()) {
            problem(
                    from,
                    "'%s' may be silent and stands for '%s', which needs a message in every slice",
                    from.name(),
                    to.name());
            return false;
        }
        return true;
    }

    private void problem(Port place, String format, Object... words) {
        problems.add(Sentence.at(place.span(), format, words));
    }
}
