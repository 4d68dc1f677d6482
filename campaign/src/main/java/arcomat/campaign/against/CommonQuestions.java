package arcomat.campaign.against;

import arcomat.campaign.Campaign;
import arcomat.campaign.Column;
import arcomat.campaign.JointWatch;
import arcomat.campaign.Trial;
import arcomat.campaign.Variation;
import arcomat.campaign.Variation.Domain;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * What two campaigns ask in the same words. Columns that are called alike and mean something else
 * are not compared.
 */
final class CommonQuestions {
    private final Campaign before;
    private final Campaign now;

    /** Parameters that tell the campaigns apart, and not runs of one of them. */
    private final Set<String> fixed = new TreeSet<>();

    CommonQuestions(Campaign before, Campaign now) {
        this.before = before;
        this.now = now;
        Stream.of(before, now)
                .flatMap(each -> each.variations().stream())
                .filter(each -> isFixed(each.domain()))
                .map(Variation::parameter)
                .filter(each -> isFixed(each, before) && isFixed(each, now))
                .forEach(fixed::add);
    }

    private static boolean isFixed(Domain domain) {
        return domain.match(range -> range.low() == range.high(), each -> each.words().size() == 1);
    }

    /** What a campaign does not vary is what the world says. */
    private static boolean isFixed(String parameter, Campaign campaign) {
        return campaign.variations().stream()
                .filter(each -> each.parameter().equals(parameter))
                .allMatch(each -> isFixed(each.domain()));
    }

    List<Column> columns() {
        return now.columns().stream().filter(this::isCommon).toList();
    }

    /** Names of those that one of them has, and the other one has not or in other words. */
    List<String> others() {
        List<String> common = columns().stream().map(Column::name).toList();
        return Stream.of(now, before)
                .flatMap(each -> each.columns().stream())
                .map(Column::name)
                .filter(each -> !common.contains(each))
                .distinct()
                .toList();
    }

    private boolean isCommon(Column column) {
        return before.columns().contains(column)
                && bindings(column, before).equals(bindings(column, now));
    }

    private static List<String> bindings(Column column, Campaign campaign) {
        List<String> bindings = new ArrayList<>();
        for (JointWatch watch : campaign.jointWatches()) {
            if (watch.name().equals(column.name())) {
                watch.bindings()
                        .forEach(each -> bindings.add(each.port() + " " + each.source().text()));
            }
        }
        return bindings;
    }

    /** The seeds of a run and its values, but for those that tell the campaigns apart. */
    Map<String, String> circumstances(Trial trial) {
        Map<String, String> all = new LinkedHashMap<>(trial.values());
        all.keySet().removeAll(fixed);
        all.put("", trial.seeds().text()); // no parameter is called so
        return all;
    }
}
