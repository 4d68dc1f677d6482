component Heir extends Belt(true) { }
