"""The facts of pages."""
import json
import re

from checks import text


def page_data(page):
    """What the page's tables are made of."""
    return json.loads(re.search('id=page-data>(.*?)</script>', text(page))[1])


def headlines(page):
    return [line for _, line in page_data(page)["headlines"]]
