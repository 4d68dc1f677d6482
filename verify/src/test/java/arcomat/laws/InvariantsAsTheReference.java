package arcomat.laws;

import arcomat.analysis.refinement.InvariantProof;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Moment;
import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.laws.draw.InvariantText;
import arcomat.laws.draw.Plug;
import arcomat.laws.naive.NaiveInvariant;
import arcomat.model.Component;
import arcomat.model.Invariant;
import arcomat.model.Value;
import arcomat.semantics.expression.Sent;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * An invariant holds where the reference finds no slice that breaks it, and the first slice that
 * does is the same. What is said of an output of a part is said of an output of the whole, too,
 * that is connected to it.
 */
final class InvariantsAsTheReference implements Law {
    private static final int INVARIANTS = 3;
    private static final int MOST_SLICES = 5;

    @Override
    public String name() {
        return "8 invariants as the reference";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        List<Plug> plugs = ComponentText.plugs(draw, false);
        List<SourceFile> files = new ArrayList<>(List.of(ComponentText.types()));
        boolean composition = draw.has(Features.COMPOSITIONS) && draw.chance(35);
        if (composition) {
            List<Plug> whole = ComponentText.withoutTotalOutputs(plugs);
            files.addAll(ComponentText.composite(draw, "a", "Main", whole, false, 0));
            plugs = whole;
        } else {
            files.add(ComponentText.atomic(draw, "a", "Main", plugs, false));
        }
        SourceFile main = files.remove(files.size() - 1);
        String body = main.text().substring(0, main.text().lastIndexOf('}'));
        StringBuilder text = new StringBuilder(body);
        if (composition && draw.chance(50)) {
            inside(draw, plugs, body, text);
        }
        for (int i = 0; i < INVARIANTS; i++) {
            String own = InvariantText.of(draw, plugs, body);
            text.append("    inv i%d: %s;\n".formatted(i, own));
        }
        files.add(new SourceFile(main.path(), text + "}\n"));
        return files;
    }

    /** The same about an output of a part and about an output of the whole. */
    private static void inside(Draw draw, List<Plug> plugs, String body, StringBuilder text) {
        Plug like = draw.one(plugs);
        text.append("    port out %s q;\n    connect p0.u -> q;\n".formatted(like.type()));
        List<Plug> more = new ArrayList<>(plugs);
        Plug shown = new Plug("q", false, like.type(), false, 0, false);
        more.addAll(List.of(shown, shown));
        String about = InvariantText.of(draw, more, body);
        text.append("    inv shown: %s;\n".formatted(about));
        text.append("    inv inside: %s;\n".formatted(about.replaceAll("\\bq\\b", "p0.u")));
    }

    @Override
    public Outcome check(Models models) {
        Component component = models.component(Pairs.LEFT);
        Outcome worst = Outcome.SKIPPED;
        Verdict shown = null;
        for (Invariant each : component.invariants()) {
            Verdict verdict = InvariantProof.check(component, List.of(), each, Questions.budget());
            Outcome outcome =
                    each.name().equals("inside")
                            ? same(shown, verdict)
                            : asTheReference(component, each, verdict);
            shown = verdict;
            worst = outcome.isBroken() || !worst.met() ? outcome : worst;
            if (outcome.isBroken()) {
                return outcome;
            }
        }
        return worst;
    }

    private static Outcome same(Verdict shown, Verdict inside) {
        boolean known = shown != null && shown.answer() != Answer.UNKNOWN;
        if (!known || inside.answer() == Answer.UNKNOWN) {
            return Outcome.SKIPPED;
        }
        return shown.answer() == inside.answer() && slices(shown) == slices(inside)
                ? Outcome.KEPT
                : Outcome.broken(
                        "an output of a part is seen differently: %s %d, %s %d"
                                .formatted(
                                        shown.answer(),
                                        slices(shown),
                                        inside.answer(),
                                        slices(inside)),
                        "verify " + Pairs.LEFT);
    }

    private static int slices(Verdict verdict) {
        return verdict.trace().size();
    }

    static Outcome asTheReference(Component component, Invariant invariant, Verdict verdict) {
        if (verdict.answer() == Answer.UNKNOWN) {
            return Outcome.SKIPPED;
        }
        int slices = Math.max(MOST_SLICES, slices(verdict));
        return NaiveInvariant.ask(component, invariant, pool(verdict), slices)
                .map(reference -> compared(invariant, verdict, reference))
                .orElse(Outcome.SKIPPED);
    }

    private static Outcome compared(
            Invariant invariant, Verdict verdict, NaiveInvariant.Answer reference) {
        boolean fails = verdict.answer() == Answer.FAILS;
        int first = reference.first().orElse(Integer.MAX_VALUE);
        int found = fails ? slices(verdict) - 1 : Integer.MAX_VALUE;
        boolean agree =
                first == found
                        || !reference.all() && first > found
                        || verdict.mayBeShorter() && first < found;
        return agree
                ? Outcome.KEPT
                : Outcome.broken(
                        "invariant %s %s in %d slices, but the reference says %s"
                                .formatted(
                                        invariant.name(),
                                        verdict.answer(),
                                        slices(verdict),
                                        reference.first()),
                        "verify " + Pairs.LEFT);
    }

    /** Of large types, what a model writes and what the run has shown. */
    private static List<Value> pool(Verdict verdict) {
        Set<Value> pool = new LinkedHashSet<>();
        for (long i = -1; i <= 3; i++) {
            pool.add(new Value.IntegerValue(i));
        }
        for (String text : List.of("", "a", "b", "c")) {
            pool.add(new Value.StringValue(text));
        }
        for (char letter : "`abc\u0000".toCharArray()) {
            pool.add(new Value.CharacterValue(letter));
        }
        for (double number : new double[] {0, 0.5, 1.5, 2, Double.NaN}) {
            pool.add(new Value.RealValue(number));
        }
        for (Moment moment : verdict.trace()) {
            moment.input().messages().values().forEach(pool::addAll);
            moment.outputs().values().stream()
                    .filter(Sent.Messages.class::isInstance)
                    .forEach(sent -> pool.addAll(((Sent.Messages) sent).values()));
        }
        return List.copyOf(pool);
    }
}
