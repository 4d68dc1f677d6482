package arcomat.laws;

import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Edits;
import arcomat.laws.draw.Features;
import arcomat.laws.draw.Plug;
import arcomat.laws.naive.Flattened;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Two components with much in common: {@code a.Main} and {@code b.Main}. */
final class Pairs {
    static final String LEFT = "a.Main";
    static final String RIGHT = "b.Main";

    private Pairs() {}

    /** As a rule they differ in a few lines; else they were drawn apart. */
    static List<SourceFile> draw(Draw draw) {
        boolean events = draw.has(Features.EVENTS) && draw.chance(15);
        return draw(draw, ComponentText.plugs(draw, events), events);
    }

    static List<SourceFile> draw(Draw draw, List<Plug> drawn, boolean events) {
        boolean composite = draw.has(Features.COMPOSITIONS) && draw.chance(45);
        List<Plug> plugs = composite ? ComponentText.withoutTotalOutputs(drawn) : drawn;
        List<SourceFile> right =
                composite && draw.chance(80)
                        ? ComponentText.composite(draw, "b", "Main", plugs, events, 0)
                        : List.of(ComponentText.atomic(draw, "b", "Main", plugs, events));
        Optional<List<SourceFile>> flat =
                composite && draw.chance(40) ? flattened(draw, right) : Optional.empty();
        if (flat.isPresent()) {
            return flat.get();
        }
        List<SourceFile> left =
                draw.chance(80)
                        ? edited(draw, moved(right, "b", "a"))
                        : apart(draw, plugs, events, composite);
        List<SourceFile> files = new ArrayList<>(List.of(ComponentText.types()));
        files.addAll(right);
        boolean more = left.size() == 1 && left.get(0).text().contains(" automaton");
        files.addAll(
                more && draw.chance(12)
                        ? List.of(new Edits(draw).withMorePorts(left.get(0)))
                        : left);
        return files;
    }

    /** A composition beside one automaton that does the same, but for some edits. */
    private static Optional<List<SourceFile>> flattened(Draw draw, List<SourceFile> composition) {
        boolean isLeft = draw.chance(60);
        String own = isLeft ? "a" : "b";
        String other = isLeft ? "b" : "a";
        List<SourceFile> files = new ArrayList<>(List.of(ComponentText.types()));
        files.addAll(moved(composition, "b", own));
        Optional<List<String>> lines =
                Models.read(files, 0).flatMap(m -> Flattened.of(m.component(own + ".Main"), other));
        lines.ifPresent(
                text -> {
                    String joined = String.join("\n", text) + "\n";
                    files.addAll(
                            edited(draw, List.of(new SourceFile(other + "/Main.arc", joined))));
                });
        return lines.map(text -> files);
    }

    private static List<SourceFile> apart(
            Draw draw, List<Plug> plugs, boolean events, boolean composite) {
        return composite
                ? ComponentText.composite(draw, "a", "Main", plugs, events, 0)
                : List.of(ComponentText.atomic(draw, "a", "Main", plugs, events));
    }

    static List<SourceFile> edited(Draw draw, List<SourceFile> files) {
        Edits edits = new Edits(draw);
        List<SourceFile> edited = files;
        for (int count = draw.below(4); count > 0; count--) {
            edited = edits.once(edited);
        }
        return edited;
    }

    /** The same in another package. */
    static List<SourceFile> moved(List<SourceFile> files, String from, String to) {
        return files.stream()
                .map(
                        f ->
                                new SourceFile(
                                        to + f.path().substring(from.length()),
                                        f.text().replace("package " + from, "package " + to)))
                .toList();
    }
}
