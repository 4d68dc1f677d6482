package arcomat.site;

import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.renderer.html.HtmlRenderer;

import java.nio.file.Path;
import java.util.List;

/**
 * A page of the site.
 *
 * @param path of its text
 * @param body what it says, as HTML
 * @param sections what a search finds
 * @param links where it leads, as they stand on it
 */
public record Page(
        Path path,
        String title,
        String body,
        List<Heading> headings,
        List<SearchText.Section> sections,
        List<String> links) {

    /**
     * @param id by which a link names it
     * @param level 1 for the title
     */
    public record Heading(String id, String text, int level) {}

    static Page of(Manuscript text, Links links, Shelf shelf, BrokenPages.Problems problems) {
        links.turn(text, problems);
        Headings headings = Headings.of(text);
        Trials trials = Trials.of(text, shelf);
        Blocks blocks = new Blocks(trials, Addresses.of(text.path()));
        HtmlRenderer renderer =
                HtmlRenderer.builder()
                        .extensions(Manuscript.EXTENSIONS)
                        .attributeProviderFactory(context -> headings)
                        .attributeProviderFactory(context -> new Looks())
                        .nodeRendererFactory(blocks::renderer)
                        .build();
        return new Page(
                text.path(),
                headings.title(),
                renderer.render(text.document()),
                headings.all(),
                SearchText.of(text.document(), headings),
                text.links().stream().map(Link::getDestination).toList());
    }

    public String address() {
        return Addresses.of(path);
    }

    boolean hasHeading(String id) {
        return headings.stream().anyMatch(each -> each.id().equals(id));
    }

    /** What a node says, without its marks. */
    static String words(Node node) {
        return SearchText.words(node).strip();
    }
}
