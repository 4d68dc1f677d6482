package arcomat.diagram;

import java.util.List;

/** A page that shows the pictures of a folder, one below the other. */
public final class GalleryPage {
    private GalleryPage() {}

    /**
     * @param files names of SVG or PNG files beside the page
     */
    public static String render(String title, List<String> files) {
        StringBuilder page = new StringBuilder();
        page.append("<!DOCTYPE html>\n<html lang=\"en\" class=\"arcomat\">\n<head>\n")
                .append("<meta charset=\"utf-8\">\n<title>" + Markup.escaped(title) + "</title>\n")
                .append("<style>\n" + Theme.ADAPTIVE.css())
                .append("body { background: var(--paper); color: var(--ink); margin: 2em auto;")
                .append(" max-width: 80em; padding: 0 1em; font-family: sans-serif; }\n")
                .append("a { color: var(--logic-line); }\n")
                .append("object, img { max-width: 100%; }\n")
                .append(
                        "</style>\n</head>\n<body>\n<h1>"
                                + Markup.escaped(title)
                                + "</h1>\n<ul>\n");
        for (String file : files) {
            String name = Markup.escaped(name(file));
            page.append("<li><a href=\"#" + name + "\">" + name + "</a></li>\n");
        }
        page.append("</ul>\n");
        files.forEach(file -> page.append(section(file)));
        return page.append("</body>\n</html>\n").toString();
    }

    private static String section(String file) {
        String name = Markup.escaped(name(file));
        String address = Markup.escaped(file);
        String picture =
                file.endsWith(".svg")
                        // Unlike an image, an object lets its links be followed.
                        ? "<object type=\"image/svg+xml\" data=\"" + address + "\"></object>"
                        : "<img loading=\"lazy\" alt=\"\" width=\"100%\" src=\"" + address + "\">";
        return "<h2 id=\"%s\"><a href=\"%s\">%s</a></h2>\n%s\n"
                .formatted(name, address, name, picture);
    }

    private static String name(String file) {
        return file.substring(0, file.lastIndexOf('.'));
    }
}
