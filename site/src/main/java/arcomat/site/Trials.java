package arcomat.site;

import arcomat.site.Shelf.Book;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.Parser;

import org.commonmark.node.FencedCodeBlock;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** What the live page begins with, for each block of a page that holds a model. */
record Trials(Map<FencedCodeBlock, Trial> all) {
    /** By which a page says that its models are read with guests, whom the live page has not. */
    private static final String GUESTS = "--with ";

    /** Shows pieces of models: what changed in them, and no more. */
    static final Path CHANGES = Path.of("CHANGELOG.md");

    /** A block, where it stands among those of its page. */
    private record Placed(FencedCodeBlock node, Fenced fenced, List<Book> books, int order) {
        Book book() {
            return books.get(0);
        }

        /** Folders of different beginnings are examples of their own. */
        String example() {
            return book().path().replaceFirst("/.*", "");
        }
    }

    static Trials of(Manuscript page, Shelf shelf) {
        if (page.path().equals(CHANGES)) {
            return new Trials(Map.of());
        }
        List<Placed> models = new ArrayList<>();
        List<Integer> commands = new ArrayList<>();
        int order = 0;
        for (FencedCodeBlock node : page.all(FencedCodeBlock.class)) {
            Fenced fenced = Fenced.of(node);
            order++;
            if (fenced.isConsole()) {
                commands.add(order);
            } else if (fenced.isModel() && !fenced.isPart() && !fenced.books().isEmpty()) {
                models.add(new Placed(node, fenced, fenced.books(), order));
            }
        }
        Map<FencedCodeBlock, Trial> all = new IdentityHashMap<>();
        for (Placed each : models) {
            if (!page.text().contains(GUESTS) || isRead(each.book())) {
                all.put(each.node(), trial(each, models, commands, shelf));
            }
        }
        return new Trials(all);
    }

    Optional<Trial> of(FencedCodeBlock block) {
        return Optional.ofNullable(all.get(block));
    }

    private static boolean isRead(Book book) {
        return Parser.parse(new SourceFile(book.path(), book.text())).findings().stream()
                .noneMatch(Diagnostic::isError);
    }

    private static Trial trial(
            Placed block, List<Placed> models, List<Integer> commands, Shelf shelf) {
        if (!block.fenced().isFile()) {
            List<Book> others = new ArrayList<>(nearest(block, models));
            return Trial.of(block.book(), block.books(), shelf.with(others));
        }
        int command =
                commands.stream()
                        .filter(each -> each > block.order())
                        .findFirst()
                        .orElse(Integer.MAX_VALUE);
        Map<String, Book> written = new LinkedHashMap<>();
        for (Placed each : models) {
            if (each.fenced().isFile() && each.example().equals(block.example())) {
                if (each.order() <= block.order()) {
                    written.put(each.book().path(), each.book());
                } else if (each.order() < command) {
                    written.putIfAbsent(each.book().path(), each.book());
                }
            }
        }
        return Trial.of(block.book(), written.values(), shelf);
    }

    /** Of the models without a path, one for each name: the one that stands nearest. */
    private static Collection<Book> nearest(Placed block, List<Placed> models) {
        Map<String, Placed> nearest = new LinkedHashMap<>();
        for (Placed each : models) {
            if (!each.fenced().isFile() && !each.book().path().equals(block.book().path())) {
                nearest.merge(
                        each.book().path(),
                        each,
                        (one, other) ->
                                distance(one, block) <= distance(other, block) ? one : other);
            }
        }
        return nearest.values().stream().map(Placed::book).toList();
    }

    private static int distance(Placed one, Placed other) {
        return Math.abs(one.order() - other.order());
    }
}
