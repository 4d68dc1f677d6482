package arcomat.site;

import org.commonmark.node.Image;
import org.commonmark.node.Link;

import java.nio.file.Path;
import java.util.Collection;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * Turns links between texts into links between pages. What is no page is looked at in the
 * repository, pictures come along.
 */
final class Links {
    private final Repository repository;
    private final Set<Path> texts;
    private final Set<Path> pictures = new TreeSet<>();

    Links(Repository repository, Set<Path> texts) {
        this.repository = repository;
        this.texts = texts;
    }

    /** The pictures that pages show. */
    Set<Path> pictures() {
        return pictures;
    }

    /** Rewrites the links of a page. */
    void turn(Manuscript page, BrokenPages.Problems problems) {
        for (Link link : page.links()) {
            link.setDestination(turned(link.getDestination(), page.path(), problems));
        }
        for (Image image : page.all(Image.class)) {
            Target.of(image.getDestination(), page.path())
                    .ifPresent(
                            target -> {
                                if (repository.isFile(target.path())) {
                                    pictures.add(target.path());
                                    image.setDestination(
                                            Addresses.between(
                                                    Addresses.of(page.path()),
                                                    Addresses.text(target.path())));
                                } else {
                                    problems.add(page.path(), "no picture " + target.path());
                                }
                            });
        }
    }

    private String turned(String destination, Path page, BrokenPages.Problems problems) {
        Optional<Target> inside = Target.of(destination, page);
        if (inside.isEmpty()) {
            return destination;
        }
        Target target = inside.get();
        Optional<Path> text = target.text(repository).filter(texts::contains);
        if (text.isPresent()) {
            return (text.get().equals(page) && !target.anchor().isEmpty()
                            ? ""
                            : Addresses.between(Addresses.of(page), Addresses.of(text.get())))
                    + target.anchor();
        }
        if (!repository.isFile(target.path()) && !repository.isFolder(target.path())) {
            problems.add(page, "leads to " + destination + ", which is not there");
        }
        return repository.outside(target.path()) + target.anchor();
    }

    /** Every heading that a link names is there. */
    static void check(Collection<Page> pages, BrokenPages.Problems problems) {
        Map<String, Page> byAddress =
                pages.stream().collect(Collectors.toMap(Page::address, Function.identity()));
        for (Page page : pages) {
            for (String link : page.links()) {
                Optional<Target> inside = Target.of(link, Path.of(page.address()));
                if (inside.isPresent() && !inside.get().anchor().isEmpty()) {
                    Page target = byAddress.get(Addresses.text(inside.get().path()));
                    if (target == null || !target.hasHeading(inside.get().anchor().substring(1))) {
                        problems.add(
                                page.path(), "leads to " + link + ", a heading that is not there");
                    }
                }
            }
        }
    }
}
