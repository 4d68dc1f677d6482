package robots;

import robots.Talk.Order;

component Words {
    timing instant;

    port in Order order, out String word;

    table {
        in order;
        out word;
        | go   | => | "go"   |;
        | halt | => | "halt" |;
        | --   | => | --     |;
    }
}
