package arcomat.check;

import arcomat.check.behaviour.action.ActionLaws;
import arcomat.check.behaviour.automaton.AutomatonLaws;
import arcomat.check.behaviour.expression.ExpressionLaws;
import arcomat.check.behaviour.item.ItemLaws;
import arcomat.check.behaviour.total.TotalLaws;
import arcomat.check.diagrams.DiagramLaws;
import arcomat.check.guest.GuestLaws;
import arcomat.check.language.LanguageLaws;
import arcomat.check.law.Law;
import arcomat.check.naming.NamingLaws;
import arcomat.check.refinement.RefinementLaws;
import arcomat.check.stereotypes.StereotypeLaws;
import arcomat.check.structure.component.ComponentLaws;
import arcomat.check.structure.connector.ConnectorLaws;
import arcomat.check.structure.feature.FeatureLaws;
import arcomat.check.structure.reference.ReferenceLaws;
import arcomat.check.tests.TestLaws;
import arcomat.symbols.signatures.BehaviourReader;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The laws that hold in a run: those of the tool, and those that guests bring.
 *
 * @param own of the tool, by the folders in which their checks lie
 */
public record LawBook(List<Law> own, List<GuestLaws> guests) {
    /** Without guests. */
    public static final LawBook OWN = of(List.of());

    public LawBook {
        own = List.copyOf(own);
        guests = List.copyOf(guests);
    }

    /** The laws of the tool and of guests with codes of their own. */
    public static LawBook of(List<GuestLaws> guests) {
        Set<String> codes = new HashSet<>();
        List<Law> own =
                Stream.of(
                                ComponentLaws.LAWS,
                                ConnectorLaws.LAWS,
                                FeatureLaws.LAWS,
                                ReferenceLaws.LAWS,
                                NamingLaws.LAWS,
                                AutomatonLaws.LAWS,
                                ExpressionLaws.LAWS,
                                ActionLaws.LAWS,
                                ItemLaws.LAWS,
                                TotalLaws.LAWS,
                                RefinementLaws.LAWS,
                                LanguageLaws.LAWS,
                                StereotypeLaws.all(codes::contains),
                                DiagramLaws.LAWS,
                                TestLaws.LAWS)
                        .flatMap(List::stream)
                        .toList();
        own.forEach(law -> codes.add(law.code()));
        guests.forEach(guest -> codes.addAll(guest.codes()));
        return new LawBook(own, guests);
    }

    /** Everybody's. */
    public List<Law> all() {
        return Stream.concat(own.stream(), guests.stream().flatMap(each -> each.laws().stream()))
                .toList();
    }

    /** Who reads behaviours in languages of guests, where names have to be known for that. */
    public BehaviourReader reader() {
        return guests.isEmpty()
                ? BehaviourReader.NONE
                : (behaviour, around) ->
                        guests.stream()
                                .flatMap(each -> each.reader().read(behaviour, around).stream())
                                .findFirst();
    }

    /** What the guest that has this code says about it, in Markdown. */
    public Optional<String> page(String code) {
        return guests.stream()
                .filter(guest -> guest.codes().contains(code))
                .findFirst()
                .map(guest -> guest.pages().apply(code).orElseGet(() -> noPage(guest, code)));
    }

    private static String noPage(GuestLaws guest, String code) {
        return "# %s A finding of guest '%s'\n\nThe guest has no page about it.\n"
                .formatted(code, guest.guest());
    }

    /**
     * Whether a finding about one file may depend on any other one. Of the tool's own laws it is
     * known how far they look, and of its own languages that they name what they need: who does not
     * ask again relies on that. A guest may look anywhere, and may name what no text names.
     */
    public boolean looksAnywhere() {
        return !guests.isEmpty();
    }

    /** Tells these laws from those of a run with other guests; empty without any. */
    public String identity() {
        return guests.stream().map(GuestLaws::identity).collect(Collectors.joining(" "));
    }
}
