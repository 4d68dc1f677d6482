package arcomat.site;

import org.commonmark.ext.gfm.tables.TableBlock;
import org.commonmark.ext.gfm.tables.TableCell;
import org.commonmark.ext.gfm.tables.TableRow;
import org.commonmark.node.Link;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;

/** How one finds from page to page: the tables of contents in {@code docs/README.md}. */
record Navigation(List<Group> groups) {
    public record Group(String title, List<Entry> entries) {}

    public record Entry(String title, String address) {}

    static Navigation of(Map<Path, Manuscript> manuscripts, BrokenPages.Problems problems) {
        Manuscript contents = Objects.requireNonNull(manuscripts.get(Repository.CONTENTS));
        List<Group> groups = new ArrayList<>();
        for (TableBlock table : contents.all(TableBlock.class)) {
            List<Entry> entries = new ArrayList<>();
            for (TableRow row : Manuscript.below(table, TableRow.class)) {
                Manuscript.below(row, Link.class).stream()
                        .findFirst()
                        .flatMap(link -> Target.of(link.getDestination(), contents.path()))
                        .map(target -> manuscripts.get(target.path()))
                        .ifPresent(page -> entries.add(entry(page)));
            }
            TableCell title = Manuscript.below(table, TableCell.class).get(0);
            groups.add(new Group(Page.words(title), entries));
        }
        Navigation navigation = new Navigation(groups);
        navigation.checkThatNoneIsMissing(manuscripts.keySet(), problems);
        return navigation;
    }

    private static Entry entry(Manuscript page) {
        return new Entry(Headings.of(page).title(), Addresses.of(page.path()));
    }

    private void checkThatNoneIsMissing(Set<Path> pages, BrokenPages.Problems problems) {
        Set<String> named = entries().stream().map(Entry::address).collect(Collectors.toSet());
        for (Path page : pages) {
            if (page.startsWith("docs")
                    && !page.equals(Repository.CONTENTS)
                    && !named.contains(Addresses.of(page))) {
                problems.add(Repository.CONTENTS, "does not name " + page);
            }
        }
    }

    /** All, in the order in which they can be read. */
    List<Entry> entries() {
        return groups.stream().flatMap(group -> group.entries().stream()).toList();
    }
}
