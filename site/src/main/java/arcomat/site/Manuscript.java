package arcomat.site;

import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** A text that becomes a page. */
record Manuscript(Path path, String text, Node document) {
    static final List<Extension> EXTENSIONS = List.of(TablesExtension.create());

    private static final Parser PARSER = Parser.builder().extensions(EXTENSIONS).build();

    /** The README, all of {@code docs}, and every text that one of them leads to. */
    static Map<Path, Manuscript> all(Repository repository) throws IOException {
        Map<Path, Manuscript> all = new TreeMap<>();
        Deque<Path> open = new ArrayDeque<>(repository.below("docs", ".md"));
        open.add(Repository.README);
        while (!open.isEmpty()) {
            Path path = open.remove();
            if (!all.containsKey(path)) {
                Manuscript manuscript = read(repository, path);
                all.put(path, manuscript);
                open.addAll(manuscript.texts(repository));
            }
        }
        return all;
    }

    private static Manuscript read(Repository repository, Path path) throws IOException {
        String text = repository.read(path);
        return new Manuscript(path, text, PARSER.parse(text));
    }

    /** What it leads to that can become a page. */
    private List<Path> texts(Repository repository) {
        List<Path> found = new ArrayList<>();
        for (Link link : links()) {
            Target.of(link.getDestination(), path)
                    .flatMap(target -> target.text(repository))
                    .ifPresent(found::add);
        }
        return found;
    }

    List<Link> links() {
        return all(Link.class);
    }

    /** All of its nodes of a kind, from top to bottom. */
    <N extends Node> List<N> all(Class<N> kind) {
        return below(document, kind);
    }

    static <N extends Node> List<N> below(Node top, Class<N> kind) {
        List<N> found = new ArrayList<>();
        top.accept(
                new AbstractVisitor() {
                    @Override
                    protected void visitChildren(Node parent) {
                        for (Node at = parent.getFirstChild(); at != null; at = at.getNext()) {
                            if (kind.isInstance(at)) {
                                found.add(kind.cast(at));
                            }
                            visitChildren(at);
                        }
                    }
                });
        return found;
    }
}
